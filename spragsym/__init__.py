"""spragsym"""
